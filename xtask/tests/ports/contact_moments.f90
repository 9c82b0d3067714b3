! ujoint.contact_moments, value: every equation as it is printed.
program contact_moments
    implicit none
    integer, parameter :: dp = kind(1.d0)
    real(dp) :: e1a(3), e2a(3), e3a(3), e3b(3), f1, f2, f3, m2, rp, la, ra, ls, x(20)
    real(dp) :: f(3), axial1, axial3, bend, lam, phi, a_twist, b_twist, a_axial, b_axial
    real(dp) :: twist_m, twist_f, hinge1, hinge3, transv1, transv3, total1, total3, m_bend, m_total, pressing
    integer :: status
    do
        read (*, *, iostat=status) x
        if (status /= 0) exit
        e1a = x(1:3)
        e2a = x(4:6)
        e3a = x(7:9)
        e3b = x(10:12)
        f1 = x(13)
        f2 = x(14)
        f3 = x(15)
        m2 = x(16)
        rp = x(17)
        la = x(18)
        ra = x(19)
        ls = x(20)
        f = f1*e1a + f2*e2a + f3*e3a
        axial1 = dot_product(f, e1a)
        axial3 = dot_product(f, e3b)
        bend = dot_product(f, cross(e1a, e3b))
        lam = la/rp
        phi = 44/(5*lam**2)
        a_twist = 1/(8 + 6*phi)
        b_twist = 0.25d0 + a_twist
        a_axial = (lam**2 + 3)/(2*(lam**2 + 6))
        b_axial = 3/(2*(lam**2 + 6))
        twist_m = a_twist*abs(m2)
        twist_f = b_twist*abs(m2)/la
        hinge1 = a_axial*abs(axial1)
        hinge3 = a_axial*abs(axial3)
        transv1 = b_axial*abs(axial3)
        transv3 = b_axial*abs(axial1)
        total1 = norm2([bend/4, twist_f, transv1])
        total3 = norm2([bend/4, twist_f, transv3])
        m_bend = abs(bend)*la/8
        m_total = norm2([m_bend, twist_m])
        pressing = 0
        if (ls > 0) pressing = 2*m_total/ls
        write (*, '(*(es25.16e3))') hinge1*ra + (total1 + pressing)*rp, hinge3*ra + (total3 + pressing)*rp
        flush (6)
    end do
contains
    function cross(a, b)
        real(dp), intent(in) :: a(3), b(3)
        real(dp) :: cross(3)
        cross = [a(2)*b(3) - a(3)*b(2), a(3)*b(1) - a(1)*b(3), a(1)*b(2) - a(2)*b(1)]
    end function cross
end program contact_moments
